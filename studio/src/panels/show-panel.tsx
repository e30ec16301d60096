import { render } from 'preact'
import type { PanelModel } from './model.ts'
import { Panel } from './panel.tsx'

/** Renders the panels into an element. */
export function showPanel(element: HTMLElement, model: PanelModel): void {
  render(<Panel model={model} />, element)
}
