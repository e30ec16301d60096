import { effect } from '@preact/signals'
import { shortcutOf } from '../shortcuts.ts'
import type { ToolHost } from '../tools/tool-host.ts'
import type { LineEditor } from './line-editor.ts'
import type { LineTool } from './line-tool.ts'

/** View in which lines can be edited: the face, or its texture. */
export interface LineView {
  element: HTMLElement
  /** Sends the pointer events of the element to the tool. */
  host: ToolHost
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Activates a tool while lines are edited. Double clicks add points to the chosen line, and keys remove them. */
export function bindLineTool(tool: LineTool, editor: LineEditor, { element, host, attempt }: LineView): void {
  effect(() => {
    if (editor.mode.value === 'off') host.leave(tool)
    else host.choose(tool)
  })
  element.addEventListener('dblclick', ({ clientX, clientY }) => {
    if (editor.mode.peek() !== 'edit') return
    const { left, top } = element.getBoundingClientRect()
    attempt(() => tool.insert({ x: clientX - left, y: clientY - top }))
  })
  element.addEventListener('keydown', (event) => {
    if (editor.mode.peek() === 'off' || shortcutOf('lines', event) !== 'remove') return
    attempt(() => editor.remove())
  })
}
