import { TOOLS } from './labels.ts'

interface Shortcut {
  /** Values of `KeyboardEvent.key`, with the prefixes `Mod+` (Control, or Command on a Mac), `Alt+` and `Shift+`. */
  readonly keys: readonly string[]
  readonly label: string
}

/** All shortcuts, by scope. A scope is the tool or the element that handles the shortcuts. */
export const SHORTCUTS = {
  everywhere: {
    undo: { keys: ['Mod+z'], label: 'Undo' },
    redo: { keys: ['Mod+Shift+z', 'Mod+y'], label: 'Redo' },
    save: { keys: ['Mod+s'], label: 'Save the project (to its folder, if it has one)' },
    cancel: { keys: ['Escape'], label: 'Cancel the gesture of the pointer' },
    list: { keys: ['?'], label: 'Show this list' },
    expression: {
      keys: ['1', '2', '3', '4', '5', '6', '7', '8', '9'],
      label: 'Play an expression of this avatar',
    },
  },
  stage: {
    overlay: { keys: ['h'], label: 'Hide or show the lines over the face' },
    wrinkles: { keys: ['w'], label: 'Hide or show the wrinkles' },
    frame: { keys: ['f'], label: 'Look at the selection' },
  },
  tools: {
    select: { keys: ['v'], label: TOOLS.select },
    draw: { keys: ['d'], label: TOOLS.draw },
    bend: { keys: ['g'], label: TOOLS.bend },
    smooth: { keys: ['s'], label: TOOLS.smooth },
    erase: { keys: ['e'], label: TOOLS.erase },
    paint: { keys: ['b'], label: TOOLS.paint },
    polygon: { keys: ['p'], label: TOOLS.polygon },
    mirror: { keys: ['m'], label: `${TOOLS.mirror}: change both halves of the face` },
  },
  face: {
    left: { keys: ['ArrowLeft'], label: 'Orbit to the left' },
    right: { keys: ['ArrowRight'], label: 'Orbit to the right' },
    up: { keys: ['ArrowUp'], label: 'Orbit upwards' },
    down: { keys: ['ArrowDown'], label: 'Orbit downwards' },
    nearer: { keys: ['+', '='], label: 'Nearer' },
    farther: { keys: ['-'], label: 'Farther' },
  },
  painting: {
    smaller: { keys: ['['], label: 'Smaller brush' },
    larger: { keys: [']'], label: 'Larger brush' },
    swap: { keys: ['x'], label: 'Exchange adding and removing' },
  },
  polygon: {
    close: { keys: ['Enter'], label: 'Close the polygon' },
    back: { keys: ['Backspace'], label: 'Remove the last point' },
    clear: { keys: ['Escape'], label: 'Discard the polygon' },
  },
  lines: {
    remove: { keys: ['Delete', 'Backspace'], label: 'Delete the point or the lines that are chosen' },
  },
  bending: {
    smaller: { keys: ['['], label: 'Fewer points move along' },
    larger: { keys: [']'], label: 'More points move along' },
  },
  linePoint: {
    left: { keys: ['ArrowLeft', 'Shift+ArrowLeft'], label: 'To the left on the face, far with Shift' },
    right: { keys: ['ArrowRight', 'Shift+ArrowRight'], label: 'To the right on the face, far with Shift' },
    up: { keys: ['ArrowUp', 'Shift+ArrowUp'], label: 'Upwards on the face, far with Shift' },
    down: { keys: ['ArrowDown', 'Shift+ArrowDown'], label: 'Downwards on the face, far with Shift' },
    remove: { keys: ['Delete', 'Backspace'], label: 'Delete the point' },
  },
  texture: {
    left: { keys: ['ArrowLeft'], label: 'To the left' },
    right: { keys: ['ArrowRight'], label: 'To the right' },
    up: { keys: ['ArrowUp'], label: 'Upwards' },
    down: { keys: ['ArrowDown'], label: 'Downwards' },
    nearer: { keys: ['+', '='], label: 'Nearer' },
    farther: { keys: ['-'], label: 'Farther' },
    reset: { keys: ['0'], label: 'The whole texture' },
  },
  curve: {
    left: { keys: ['ArrowLeft', 'Shift+ArrowLeft'], label: 'To the left, far with Shift' },
    right: { keys: ['ArrowRight', 'Shift+ArrowRight'], label: 'To the right, far with Shift' },
    up: { keys: ['ArrowUp', 'Shift+ArrowUp'], label: 'Upwards, far with Shift' },
    down: { keys: ['ArrowDown', 'Shift+ArrowDown'], label: 'Downwards, far with Shift' },
    remove: { keys: ['Delete', 'Backspace'], label: 'Delete the point' },
  },
  divider: {
    left: { keys: ['ArrowLeft', 'ArrowDown'], label: 'To the left' },
    right: { keys: ['ArrowRight', 'ArrowUp'], label: 'To the right' },
    farLeft: { keys: ['PageDown', 'Shift+ArrowLeft', 'Shift+ArrowDown'], label: 'Far to the left' },
    farRight: { keys: ['PageUp', 'Shift+ArrowRight', 'Shift+ArrowUp'], label: 'Far to the right' },
    start: { keys: ['Home'], label: 'Wrinkles everywhere' },
    end: { keys: ['End'], label: 'Wrinkles nowhere' },
  },
} as const satisfies Record<string, Record<string, Shortcut>>

export type Scope = keyof typeof SHORTCUTS
export type ShortcutName<S extends Scope> = keyof (typeof SHORTCUTS)[S] & string

/** Returns the shortcut of a key event in a scope, or undefined for other keys and for text input. */
export function shortcutOf<S extends Scope>(scope: S, event: KeyboardEvent): ShortcutName<S> | undefined {
  const pressed = keyOf(event)
  if (isTyped(pressed, event.target)) return undefined
  const entries = Object.entries<Shortcut>(SHORTCUTS[scope])
  return entries.find(([, { keys }]) => keys.includes(pressed))?.[0] as ShortcutName<S> | undefined
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
  if (target instanceof HTMLSelectElement) return !pressed.startsWith('Mod+')
  return target instanceof HTMLInputElement && !['range', 'checkbox', 'radio', 'file'].includes(target.type)
}
