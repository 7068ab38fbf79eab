/* A message and a sum with each of the two protobufs of one program; 0, or the number of the step that failed. */
#pragma once
extern "C" {
int with_tensorflow();
int with_system();
}
