import type { Ray } from 'three'

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

export interface StageTool {
  /** Whether the tool leaves the divider and the pointer of the stage as they are. */
  readonly isQuiet?: boolean
  /** Returns a promise that settles when the tool is ready, or null if there is nothing to wait for. Pointer events are delayed until then. */
  preparation?(): Promise<unknown> | null
  /** Begins a gesture. Returns whether the tool captures the pointer until release. Otherwise, the camera orbits. */
  begin(pointer: StagePointer): boolean
  /** @param pointers all positions since the last call, in order. */
  move(pointers: readonly StagePointer[]): void
  end(): void
  /** Aborts the gesture, after Escape, a lost pointer or a change of the tool. */
  cancel(): void
  /** Called when the pointer moves while no button is pressed, and with null when it leaves. */
  hover?(pointer: StagePointer | null): void
}
