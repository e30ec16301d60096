import type { Signal } from '@preact/signals'
import { FILE } from '../labels.ts'
import { type Scope, SHORTCUTS } from '../shortcuts.ts'
import { Dialog } from '../ui/dialog.tsx'

const SCOPES: Record<Scope, string> = {
  everywhere: 'Everywhere',
  stage: 'Stage',
  tools: 'Tools',
  face: 'On the face',
  painting: 'While painting',
  polygon: 'While a polygon is drawn',
  lines: 'On the face, while lines are edited',
  bending: 'While lines are bent',
  linePoint: 'On a point of a line, in the panel',
  texture: 'On the texture',
  curve: 'On a point of a curve',
  divider: 'On the divider',
}

const isMac = /^Mac/.test(navigator.platform)
const SIGNS: Record<string, string> = {
  Mod: isMac ? '⌘' : 'Ctrl',
  Escape: 'Esc',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  PageUp: 'Page up',
  PageDown: 'Page down',
}

export function ShortcutList({ isOpen }: { isOpen: Signal<boolean> }) {
  return (
    <Dialog title={FILE.shortcuts} isOpen={isOpen}>
      <div class="shortcuts">
        {(Object.keys(SCOPES) as Scope[]).map((scope) => (
          <section key={scope}>
            <h3>{SCOPES[scope]}</h3>
            <dl>
              {Object.entries(SHORTCUTS[scope]).map(([name, { keys, label }]) => (
                <div key={name}>
                  <dt>
                    <Keys keys={keys} />
                  </dt>
                  <dd>{label}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  )
}

/** Alternative keys of a shortcut. */
function Keys({ keys }: { keys: readonly string[] }) {
  return keys.map((key) => <kbd key={key}>{signOf(key)}</kbd>)
}

/** Formats keys such as `Mod+z` with the labels of the user's keyboard. */
function signOf(key: string): string {
  if (key.length === 1) return key.toUpperCase()
  return key
    .split('+')
    .map((part) => SIGNS[part] ?? (part.length === 1 ? part.toUpperCase() : part))
    .join(' ')
}
