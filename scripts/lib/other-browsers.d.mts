/** The browser that ships with WebKitGTK. */
export const MINI_BROWSER: string

/** Programs that tests in each browser need, with the Debian package of each. */
export const PROGRAMS: Record<'firefox' | 'webkit', Record<string, string>>

/** Lists the missing Debian packages for tests in a browser. */
export function missingPackages(browser: 'firefox' | 'webkit'): string[]
