import { Fetched } from '../material/fetched.ts'

/** What fades wrinkles of faces that are small on screen: fetched for pages that want that. */
export const FADE = new Fetched(async () => (await import('../camera/size-on-screen.ts')).fadeOnScreen)
