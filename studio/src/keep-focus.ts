const FOCUSABLE =
  'button:not(:disabled), input:not(:disabled), select:not(:disabled), textarea, summary, [tabindex="0"]'

/**
 * Moves the focus when the focused element is removed, disabled or hidden, for example by deleting a row. The new focus is an element near
 * the removed one, or otherwise the previously focused element. Does nothing if the last input came from a pointer.
 *
 * @param page element that contains all focusable elements.
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
    // Browsers also send this event when they remove the focused element. If the element is still connected later, the user has moved the focus.
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

/**
 * Focused element and its position on the page: its ancestors below the landmark (`main`, `aside` or a dialog), each with the index of the
 * child that contains the element.
 */
interface Held {
  readonly element: HTMLElement
  readonly path: readonly (readonly [ancestor: Element, index: number])[]
}

function hold(element: HTMLElement): Held {
  const path: [Element, number][] = []
  let child: Element = element
  while (child.parentElement && !child.matches('main, aside, [role=dialog], body')) {
    path.push([child.parentElement, [...child.parentElement.children].indexOf(child)])
    child = child.parentElement
  }
  // Exclude the landmark, because its children are unrelated to each other.
  return { element, path: path.slice(0, -1) }
}

function isFocusable(element: HTMLElement): boolean {
  return element.isConnected && !element.matches(':disabled') && element.checkVisibility()
}

/**
 * Finds a focusable element near a removed one: in the nearest sibling that contains one, and otherwise near an ancestor. There, prefers an
 * element with the class of the removed one.
 */
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
