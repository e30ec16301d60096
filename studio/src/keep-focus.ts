const FOCUSABLE =
  'button:not(:disabled), input:not(:disabled), select:not(:disabled), textarea, summary, [tabindex="0"]'

/**
 * Keeps the keyboard focus on the page. If the focused element is removed, the focus moves to the element in its place, or else to the
 * previously focused one. Examples: a deleted row, a form removed by undo, a dismissed message.
 *
 * @param page root of all focusable elements, in landmarks.
 */
export function keepFocus(page: HTMLElement): void {
  let held: Held | null = null
  let before: Held | null = null
  let isKeyboard = false
  page.addEventListener('keydown', () => (isKeyboard = true), { capture: true })
  page.addEventListener('pointerdown', () => (isKeyboard = false), { capture: true })
  page.addEventListener('focusin', ({ target }) => {
    if (held?.element.isConnected) before = held
    held = hold(target as HTMLElement)
  })
  page.addEventListener('focusout', ({ target, relatedTarget }) => {
    const { isConnected } = target as HTMLElement
    // The user left the element. Browsers send the same event before or during the removal of an element.
    queueMicrotask(() => {
      if (!relatedTarget && isConnected && (target as HTMLElement).isConnected) held = null
    })
  })
  new MutationObserver(() => {
    if (!held || isFocusable(held.element) || document.activeElement !== document.body) return
    const next = successorOf(held) ?? (before && isFocusable(before.element) ? before.element : null)
    held = null
    if (isKeyboard) next?.focus()
  }).observe(page, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ['disabled', 'hidden'],
  })
}

/** Focused element and its position: its ancestors up to the landmark, each with the index of the child that contains it. */
interface Held {
  readonly element: HTMLElement
  readonly path: readonly (readonly [ancestor: Element, index: number])[]
}

function hold(element: HTMLElement): Held {
  const path: [Element, number][] = []
  let child: Element = element
  while (child.parentElement && !child.matches('main, aside, dialog, body')) {
    path.push([child.parentElement, [...child.parentElement.children].indexOf(child)])
    child = child.parentElement
  }
  // Exclude the landmark: its children are unrelated.
  return { element, path: path.slice(0, -1) }
}

function isFocusable(element: HTMLElement): boolean {
  return element.isConnected && !element.matches(':disabled') && element.checkVisibility()
}

/** Finds the element at a former position: of the same class in the next row if possible, or else the nearest. */
function successorOf({ element, path }: Held): HTMLElement | null {
  for (const [ancestor, index] of path) {
    if (!ancestor.isConnected || !ancestor.checkVisibility()) continue
    const children = [...ancestor.children]
    const near = [...children.slice(index), ...children.slice(0, index).reverse()]
    for (const child of near) {
      const inside = [child, ...child.querySelectorAll(FOCUSABLE)].filter(
        (each): each is HTMLElement => each.matches(FOCUSABLE) && isFocusable(each as HTMLElement),
      )
      if (inside.length > 0)
        return inside.find(({ className }) => className === element.className) ?? inside[0]
    }
  }
  return null
}
