/** WebKitGTK's own browser. */
export const MINI_BROWSER: string

/** Debian packages that must still be installed for tests in a browser. */
export function missingPackages(browser: 'firefox' | 'webkit'): string[]
