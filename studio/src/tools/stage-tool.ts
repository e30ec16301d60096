import type { Ray } from 'three'

/** Pointer on the stage. */
export interface StagePointer {
  /** Ray from the camera through the pointer, world space. */
  readonly ray: Ray
  /** Pen pressure, 0..1; 1 for other devices. */
  readonly pressure: number
  /** Position in CSS pixels from the stage's upper left corner. */
  readonly x: number
  readonly y: number
  readonly shift: boolean
  readonly alt: boolean
}

/** Pointer tool of the stage. */
export interface StageTool {
  /** Returns a pending preparation, or null. Settling it, also with an error, replays the pointer events received meanwhile. */
  preparation?(): Promise<unknown> | null
  /** @returns whether the tool captures the pointer until release; otherwise the camera orbits. */
  begin(pointer: StagePointer): boolean
  /** @param pointers all positions since the last call, in order. */
  move(pointers: readonly StagePointer[]): void
  end(): void
  /** Aborts the gesture: Escape, a lost pointer, or another tool. */
  cancel(): void
  /** Receives pointer moves without a pressed button, and null when the pointer leaves. */
  hover?(pointer: StagePointer | null): void
}
