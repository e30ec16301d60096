/**
 * Keys of all shortcuts, by scope. A scope is the tool or the element that handles the shortcuts. Keys are values of `KeyboardEvent.key`, with the
 * prefixes `Mod+` (Control, or Command on a Mac), `Alt+` and `Shift+`.
 */
export const SHORTCUTS = {
  everywhere: {
    undo: ['Mod+z'],
    redo: ['Mod+Shift+z', 'Mod+y'],
    save: ['Mod+s'],
    cancel: ['Escape'],
    list: ['?'],
    expression: ['1', '2', '3', '4', '5', '6', '7', '8', '9'],
  },
  stage: {
    overlay: ['h'],
    wrinkles: ['w'],
    frame: ['f'],
  },
  tools: {
    select: ['v'],
    draw: ['d'],
    bend: ['g'],
    smooth: ['s'],
    erase: ['e'],
    paint: ['b'],
    polygon: ['p'],
    sculpt: ['c'],
    mirror: ['m'],
  },
  motion: {
    play: [' '],
    record: ['r'],
    in: ['i'],
    out: ['o'],
  },
  face: {
    left: ['ArrowLeft'],
    right: ['ArrowRight'],
    up: ['ArrowUp'],
    down: ['ArrowDown'],
    nearer: ['+', '='],
    farther: ['-'],
  },
  painting: {
    smaller: ['['],
    larger: [']'],
    swap: ['x'],
  },
  polygon: {
    close: ['Enter'],
    back: ['Backspace'],
    clear: ['Escape'],
  },
  lines: {
    remove: ['Delete', 'Backspace'],
  },
  bending: {
    smaller: ['['],
    larger: [']'],
  },
  linePoint: {
    left: ['ArrowLeft', 'Shift+ArrowLeft'],
    right: ['ArrowRight', 'Shift+ArrowRight'],
    up: ['ArrowUp', 'Shift+ArrowUp'],
    down: ['ArrowDown', 'Shift+ArrowDown'],
    remove: ['Delete', 'Backspace'],
  },
  texture: {
    left: ['ArrowLeft'],
    right: ['ArrowRight'],
    up: ['ArrowUp'],
    down: ['ArrowDown'],
    nearer: ['+', '='],
    farther: ['-'],
    reset: ['0'],
  },
  curve: {
    left: ['ArrowLeft', 'Shift+ArrowLeft'],
    right: ['ArrowRight', 'Shift+ArrowRight'],
    up: ['ArrowUp', 'Shift+ArrowUp'],
    down: ['ArrowDown', 'Shift+ArrowDown'],
    remove: ['Delete', 'Backspace'],
  },
  skeleton: {
    left: ['ArrowLeft', 'Shift+ArrowLeft'],
    right: ['ArrowRight', 'Shift+ArrowRight'],
    up: ['ArrowUp'],
    down: ['ArrowDown'],
  },
  divider: {
    left: ['ArrowLeft', 'ArrowDown'],
    right: ['ArrowRight', 'ArrowUp'],
    farLeft: ['PageDown', 'Shift+ArrowLeft', 'Shift+ArrowDown'],
    farRight: ['PageUp', 'Shift+ArrowRight', 'Shift+ArrowUp'],
    start: ['Home'],
    end: ['End'],
  },
} as const satisfies Record<string, Record<string, readonly string[]>>

export type Scope = keyof typeof SHORTCUTS
export type ShortcutName<S extends Scope> = keyof (typeof SHORTCUTS)[S] & string

/** Returns the shortcut of a key event in a scope, or undefined for other keys and for text input. */
export function shortcutOf<S extends Scope>(scope: S, event: KeyboardEvent): ShortcutName<S> | undefined {
  const pressed = keyOf(event)
  if (isTyped(pressed, event.target)) return undefined
  const entries = Object.entries<readonly string[]>(SHORTCUTS[scope])
  return entries.find(([, keys]) => keys.includes(pressed))?.[0] as ShortcutName<S> | undefined
}

/** Handles the shortcuts of the scope `everywhere`. Prevents the browser's default actions for these keys. */
export function addShortcuts(actions: GlobalActions): void {
  addEventListener('keydown', (event) => {
    const name = shortcutOf('everywhere', event)
    // The tool host handles `cancel`.
    if (!name || name === 'cancel' || event.defaultPrevented) return
    event.preventDefault()
    if (name === 'expression') actions.expression(Number(event.key))
    else actions[name]()
  })
  addEventListener('keydown', (event) => {
    const [tool, view] = [shortcutOf('tools', event), shortcutOf('stage', event)]
    if ((!tool && !view) || event.defaultPrevented) return
    event.preventDefault()
    if (tool) actions.tool(tool)
    if (view) actions[view]()
  })
  addEventListener('keydown', (event) => {
    const name = shortcutOf('motion', event)
    if (name && !event.defaultPrevented && actions.motion(name)) event.preventDefault()
  })
}

/** Actions of the shortcuts that work everywhere. */
interface GlobalActions
  extends Record<
    Exclude<ShortcutName<'everywhere'>, 'cancel' | 'expression'> | ShortcutName<'stage'>,
    () => void
  > {
  /** @param number number of the expression, from 1. */
  expression(number: number): void
  tool(tool: ShortcutName<'tools'>): void
  /** @returns whether the page plays motion, so that it uses the shortcut. */
  motion(name: ShortcutName<'motion'>): boolean
}

/** Returns pressed keys in the notation of `SHORTCUTS`. Includes Shift only with `Mod+` and with keys that type no character. */
function keyOf(event: KeyboardEvent): string {
  const { key, altKey, ctrlKey, metaKey, shiftKey } = event
  // AltGr also sets `ctrlKey` and `altKey`. Some keyboards type brackets with it.
  const isCharacter = event.getModifierState('AltGraph')
  const isModified = !isCharacter && (ctrlKey || metaKey)
  const name = key.length === 1 ? key.toLowerCase() : key
  const alt = altKey && !isCharacter ? 'Alt+' : ''
  const shift = shiftKey && (isModified || key.length > 1) ? 'Shift+' : ''
  return `${isModified ? 'Mod+' : ''}${alt}${shift}${name}`
}

/** Whether an element uses a key itself, to type text or to choose from a list. */
function isTyped(pressed: string, target: EventTarget | null): boolean {
  if (typeof HTMLInputElement === 'undefined') return false
  if (target instanceof HTMLTextAreaElement) return true
  if (
    pressed === ' ' &&
    target instanceof Element &&
    target.closest('button, summary, input:not([type=range]), label, a')
  )
    return true
  if (target instanceof HTMLSelectElement) return !pressed.startsWith('Mod+')
  return target instanceof HTMLInputElement && !['range', 'checkbox', 'radio', 'file'].includes(target.type)
}
