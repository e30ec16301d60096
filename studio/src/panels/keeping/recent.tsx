import type { ProjectEntry } from '../../keep/project-store.ts'
import { Section } from '../controls/section.tsx'
import type { PanelModel } from '../model.ts'

export function Recent({ model: { projects, actions } }: { model: PanelModel }) {
  const entries = projects.value
  if (entries.length === 0) return null
  return (
    <Section title="Recent work" open={false}>
      <ul class="list">
        {entries.map((entry) => (
          <li key={entry.id}>
            <button
              type="button"
              disabled={entry.problem !== undefined}
              title={entry.problem}
              onClick={() => actions.openProject(entry.id)}
            >
              {entry.name}
              <time>{dateOf(entry)}</time>
            </button>
            <button
              type="button"
              class="remove"
              title="Delete"
              aria-label={`Delete ${entry.name}`}
              onClick={() => actions.deleteProject(entry.id)}
            >
              ×
            </button>
          </li>
        ))}
      </ul>
    </Section>
  )
}

function dateOf({ changed }: ProjectEntry): string {
  return changed?.toLocaleString(undefined, { dateStyle: 'medium', timeStyle: 'short' }) ?? ''
}
