import type { Signal } from '@preact/signals'
import { FILE } from '../labels/project.ts'
import { KEYS, SCOPES, SHORTCUT_LABELS } from '../labels/shortcuts.ts'
import { type Scope, SHORTCUTS } from '../shortcuts.ts'
import { Dialog } from '../ui/dialog.tsx'

const isMac = /^Mac/.test(navigator.platform)
const SIGNS: Readonly<Record<string, string>> = { ...KEYS, Mod: isMac ? '⌘' : 'Ctrl' }

export function ShortcutList({ isOpen }: { isOpen: Signal<boolean> }) {
  return (
    <Dialog title={FILE.shortcuts} isOpen={isOpen}>
      <div class="shortcuts">
        {(Object.keys(SCOPES) as Scope[]).map((scope) => (
          <section key={scope}>
            <h3>{SCOPES[scope]}</h3>
            <dl>
              {Object.entries<string>(SHORTCUT_LABELS[scope]).map(([name, label]) => (
                <div key={name}>
                  <dt>
                    <Keys keys={keysOf(scope, name)} />
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

function keysOf(scope: Scope, name: string): readonly string[] {
  return (SHORTCUTS[scope] as Readonly<Record<string, readonly string[]>>)[name]
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
