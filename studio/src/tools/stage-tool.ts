import type { Ray } from 'three'

/** A pointer on the stage. */
export interface StagePointer {
  /** From the camera through the pointer, in world space. */
  readonly ray: Ray
  /** 0..1; 1 where the device has none. */
  readonly pressure: number
  /** CSS pixels from the stage's upper left corner. */
  readonly x: number
  readonly y: number
  readonly shift: boolean
  readonly alt: boolean
}

/** What the pointer does on the face while it is chosen. */
export interface StageTool {
  /** What the tool waits for before it can begin, an error included; null where it can. What the pointer does meanwhile is done then. */
  waitsFor?(): Promise<unknown> | null
  /** @returns whether the tool takes the pointer until it is let go; otherwise the camera orbits. */
  begin(pointer: StagePointer): boolean
  /** @param pointers all positions since the last call, in order. */
  move(pointers: readonly StagePointer[]): void
  end(): void
  /** Ends without a result: Escape, a lost pointer, another tool. */
  cancel(): void
  /** The pointer moves without being pressed; null when it leaves. */
  hover?(pointer: StagePointer | null): void
}
