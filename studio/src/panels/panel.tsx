import { Animation } from './animation.tsx'
import { Areas } from './areas/areas.tsx'
import { AutomaticWrinkles } from './automatic.tsx'
import { Expressions } from './expressions.tsx'
import { Export } from './keeping/export.tsx'
import { Recent } from './keeping/recent.tsx'
import { Layers } from './layers.tsx'
import { Lines } from './lines.tsx'
import type { PanelModel } from './model.ts'
import { Settings } from './settings.tsx'
import { Shapes } from './shapes/shapes.tsx'
import { ShortcutList } from './shortcut-list.tsx'
import { Targets } from './targets.tsx'
import { Title } from './title.tsx'

export function Panel({ model }: { model: PanelModel }) {
  return (
    <>
      <Title model={model} />
      <ShortcutList isOpen={model.isListOpen} />
      <Recent model={model} />
      <Expressions model={model} />
      {model.player.clips.value.length > 0 && <Animation player={model.player} />}
      {model.session.document.value?.auto && <AutomaticWrinkles model={model} />}
      {model.session.document.value && (model.viewer.value?.targets.length ?? 0) > 0 && (
        <Shapes model={model} />
      )}
      {model.session.document.value && <Lines model={model} />}
      <Settings model={model} />
      <Areas model={model} />
      {model.session.document.value && <Layers model={model} />}
      <Targets model={model} />
      {model.session.document.value && <Export model={model} />}
    </>
  )
}
