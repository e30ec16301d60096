import type { Scope, ShortcutName } from '../shortcuts.ts'
import { TOOLS } from './page.ts'

/** Headings of the list of shortcuts, in the order of the list. */
export const SCOPES: Readonly<Record<Scope, string>> = {
  everywhere: 'Everywhere',
  stage: 'Stage',
  tools: 'Tools',
  motion: 'In the mode Motion',
  face: 'On the face',
  painting: 'While painting',
  polygon: 'While a polygon is drawn',
  lines: 'On the face, while lines are edited',
  bending: 'While lines are bent',
  linePoint: 'On a point of a line, in the panel',
  texture: 'On the texture',
  curve: 'On a point of a curve',
  skeleton: 'On a bone of the skeleton',
  divider: 'On the divider',
}

/** Effects of the shortcuts. */
export const SHORTCUT_LABELS: { readonly [scope in Scope]: Readonly<Record<ShortcutName<scope>, string>> } = {
  everywhere: {
    undo: 'Undo',
    redo: 'Redo',
    save: 'Save the project (to its folder, if it has one)',
    cancel: 'Cancel the gesture of the pointer',
    list: 'Show this list',
    expression: 'Play an expression of this avatar',
  },
  stage: {
    overlay: 'Hide or show the lines over the face',
    wrinkles: 'Hide or show the wrinkles',
    frame: 'Look at the selection',
  },
  tools: { ...TOOLS, mirror: `${TOOLS.mirror}: change both halves of the face` },
  motion: {
    play: 'Play or pause',
    record: 'Record a take, or finish it (while a source is live)',
    in: 'Begin the take at this time',
    out: 'End the take at this time',
  },
  face: {
    left: 'Orbit to the left',
    right: 'Orbit to the right',
    up: 'Orbit upwards',
    down: 'Orbit downwards',
    nearer: 'Nearer',
    farther: 'Farther',
  },
  painting: {
    smaller: 'Smaller brush',
    larger: 'Larger brush',
    swap: 'Exchange adding and removing, or raising and lowering',
  },
  polygon: {
    close: 'Close the polygon',
    back: 'Remove the last point',
    clear: 'Discard the polygon',
  },
  lines: {
    remove: 'Delete the point or the lines that are chosen',
  },
  bending: {
    smaller: 'Fewer points move along',
    larger: 'More points move along',
  },
  linePoint: {
    left: 'To the left on the face, far with Shift',
    right: 'To the right on the face, far with Shift',
    up: 'Upwards on the face, far with Shift',
    down: 'Downwards on the face, far with Shift',
    remove: 'Delete the point',
  },
  texture: {
    left: 'To the left',
    right: 'To the right',
    up: 'Upwards',
    down: 'Downwards',
    nearer: 'Nearer',
    farther: 'Farther',
    reset: 'The whole texture',
  },
  curve: {
    left: 'To the left, far with Shift',
    right: 'To the right, far with Shift',
    up: 'Upwards, far with Shift',
    down: 'Downwards, far with Shift',
    remove: 'Delete the point',
  },
  skeleton: {
    left: 'Turn it counterclockwise, far with Shift',
    right: 'Turn it clockwise, far with Shift',
    up: 'The bone before it',
    down: 'The bone after it',
  },
  divider: {
    left: 'To the left',
    right: 'To the right',
    farLeft: 'Far to the left',
    farRight: 'Far to the right',
    start: 'Wrinkles everywhere',
    end: 'Wrinkles nowhere',
  },
}

/** Names of keys on the keyboard, by `KeyboardEvent.key`. */
export const KEYS = {
  ' ': 'Space',
  Escape: 'Esc',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  PageUp: 'Page up',
  PageDown: 'Page down',
} as const
