import type { StageTool } from '../../../studio/src/tools/stage-tool.ts'
import { pointerAt } from './paint/skins.ts'

/** Tool host that tests move like a hand. It cancels the gesture like `ToolHost`. */
export class ToolHand {
  #tool: StageTool | null = null
  #isHeld = false

  get isHeld(): boolean {
    return this.#isHeld
  }

  choose(tool: StageTool): void {
    this.cancel()
    this.#tool = tool
  }

  leave(tool: StageTool): void {
    if (this.#tool === tool) this.#tool = null
  }

  cancel(): void {
    if (!this.#isHeld) return
    this.#isHeld = false
    this.#tool!.cancel()
  }

  /** Moves the pressed pointer from one height on the sheet to another, metres. @param advance draws a frame after each event. */
  drag(advance: () => void, ...ys: number[]): void {
    this.#isHeld = this.#tool!.begin(pointerAt(0, ys[0]))
    advance()
    for (const y of ys.slice(1)) {
      this.#tool!.move([pointerAt(0, y)])
      advance()
    }
  }

  /** Moves the released pointer to a height on the sheet, metres. Null: off the stage. */
  hover(y: number | null): void {
    this.#tool!.hover!(y === null ? null : pointerAt(0, y))
  }

  release(): void {
    this.#isHeld = false
    this.#tool!.end()
  }
}
