import type { ProjectEntry } from '../../keep/project-store.ts'
import { deleteProjectLabel, KEEPING } from '../../labels/project.ts'
import type { PanelModel } from '../model.ts'

export function Recent({ model: { projects, actions } }: { model: PanelModel }) {
  const entries = projects.value
  if (entries.length === 0) return null
  return (
    <section aria-labelledby="recent">
      <h2 id="recent">{KEEPING.recent}</h2>
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
              title={KEEPING.remove}
              aria-label={deleteProjectLabel(entry.name)}
              onClick={() => actions.deleteProject(entry.id)}
            >
              ×
            </button>
          </li>
        ))}
      </ul>
    </section>
  )
}

function dateOf({ changed }: ProjectEntry): string {
  return changed?.toLocaleString(undefined, { dateStyle: 'medium', timeStyle: 'short' }) ?? ''
}
