import { type ComponentType, render } from 'preact'
import { createPortal } from 'preact/compat'
import '../ui/change-events.ts'
import { AutoProgress } from '../panels/auto-progress.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Timeline } from '../panels/motion/timeline.tsx'
import { BottomBar } from './bottom-bar.tsx'
import { Cards } from './cards.tsx'
import { Corner } from './corner.tsx'
import { Drawer } from './drawer.tsx'
import { HintCard } from './hint-card.tsx'
import { Inspector } from './inspector.tsx'
import { SheetTabs } from './sheet-tabs.tsx'
import { StartCard } from './start-card.tsx'
import { Toolbar } from './toolbar.tsx'
import { TopBar } from './top-bar.tsx'

/** Parts of the page around the stage. The keys are the ids of their elements in `index.html`. */
const PARTS = {
  start: StartCard,
  hints: HintCard,
  top: TopBar,
  tools: Toolbar,
  drawer: Drawer,
  inspector: Inspector,
  timeline: Timeline,
  poses: BottomBar,
  cards: Cards,
  corner: Corner,
  run: AutoProgress,
  'sheet-tabs': SheetTabs,
} as const satisfies Record<string, ComponentType<{ model: PanelModel }>>

/** Renders all parts in one tree, because `useId` gives unique ids only within a tree. */
export function showShell(model: PanelModel): void {
  render(<Shell model={model} />, document.createElement('div'))
}

function Shell({ model }: { model: PanelModel }) {
  return (
    <>
      {Object.entries(PARTS).map(([id, Part]) =>
        createPortal(<Part key={id} model={model} />, document.getElementById(id)!),
      )}
    </>
  )
}
