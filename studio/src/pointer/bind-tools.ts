import { effect } from '@preact/signals'
import type { LineEditor, LineMode } from '../lines/line-editor.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import type { Painting } from '../tools/painting.ts'
import type { Sculpting } from '../tools/sculpting.ts'
import type { Tool, ToolChoice } from '../tools/tool-choice.ts'

/** Effect of each tool on lines. Tools that are missing here do not use lines. */
const LINE_MODES: Readonly<Partial<Record<Tool, LineMode>>> = {
  select: 'select',
  draw: 'draw',
  bend: 'edit',
  smooth: 'smooth',
  erase: 'erase',
}

interface Parts {
  session: Session
  areas: AreaEditor
  painting: Painting
  sculpting: Sculpting
  lines: LineEditor
}

/** Activates the chosen tool. When the document closes, chooses the first tool again. */
export function bindTools(tools: ToolChoice, { session, areas, painting, sculpting, lines }: Parts): void {
  effect(() => {
    const tool = tools.tool.value
    const isPainting = tool === 'paint' || tool === 'polygon'
    if (isPainting) painting.shape.value = tool === 'paint' ? 'brush' : 'polygon'
    const isSculpting = tool === 'sculpt'
    lines.mode.value = LINE_MODES[tool] ?? 'off'
    painting.isOn.value = isPainting
    sculpting.isOn.value = isSculpting
    if (isPainting || isSculpting || tool === 'draw') lines.choose(null)
    if (!isPainting && !isSculpting) areas.forgetAdded()
  })
  effect(() => {
    const mirror = tools.mirror.value
    if (painting.brush.peek().mirror !== mirror) painting.brush.value = { ...painting.brush.peek(), mirror }
    if (sculpting.settings.peek().mirror !== mirror)
      sculpting.settings.value = { ...sculpting.settings.peek(), mirror }
    lines.mirrored.value = mirror
  })
  effect(() => {
    if (!session.document.value) tools.choose('select')
  })
  effect(() => {
    // A chosen line hides the chosen region, so a new line ends the choice of the region.
    if (lines.chosen.value && tools.mode.peek() !== 'paint') areas.choose(null)
  })
}
