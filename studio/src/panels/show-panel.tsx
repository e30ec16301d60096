import { render } from 'preact'
import type { PanelModel } from './model.ts'
import { Panel } from './panel.tsx'

/** Draws the controls into an element; they follow the model's signals from then on. */
export function showPanel(element: HTMLElement, model: PanelModel): void {
  render(<Panel model={model} />, element)
}
