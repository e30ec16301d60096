import { render } from 'preact'
import type { PanelModel } from './model.ts'
import { Panel } from './panel.tsx'

export function showPanel(element: HTMLElement, model: PanelModel): void {
  render(<Panel model={model} />, element)
}
