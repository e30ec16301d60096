import { displayName } from '../display-name.ts'
import { Section } from './controls/section.tsx'
import type { PanelModel } from './model.ts'

export function Expressions({ model: { viewer, revision, expression, actions } }: { model: PanelModel }) {
  revision.value
  return (
    <Section title="Expression" id="expressions">
      <fieldset id="expressions" class="grid" aria-labelledby="expressions-title">
        {viewer.value?.expressionNames.map((name) => (
          <button
            key={name}
            type="button"
            aria-pressed={expression.value === name}
            onClick={() => actions.play(name)}
          >
            {displayName(name)}
          </button>
        ))}
      </fieldset>
    </Section>
  )
}
