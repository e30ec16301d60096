import { afterEach, beforeEach, type MockInstance, vi } from 'vitest'

type Spy = MockInstance<(...parts: unknown[]) => void>

/** Records the warnings and errors of each test instead of printing them. Call inside `describe`. */
export function quietConsole(): { readonly warn: Spy; readonly error: Spy } {
  const spies = {} as { warn: Spy; error: Spy }
  beforeEach(() => {
    spies.warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    spies.error = vi.spyOn(console, 'error').mockImplementation(() => {})
  })
  afterEach(() => void vi.restoreAllMocks())
  return spies
}
