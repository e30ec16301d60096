import { Areas } from './areas.tsx'
import { Expressions } from './expressions.tsx'
import type { PanelModel } from './model.ts'
import { Settings } from './settings.tsx'
import { Targets } from './targets.tsx'

/** The controls beside the stage: they show the face, and request changes. */
export function Panel({ model }: { model: PanelModel }) {
  return (
    <>
      <header class="title">
        <h1>Furrow</h1>
        <p>Wrinkles for any glTF character, in real time</p>
      </header>
      <Expressions model={model} />
      <Settings model={model} />
      <Areas model={model} />
      <Targets model={model} />
    </>
  )
}
