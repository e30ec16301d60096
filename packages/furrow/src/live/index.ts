/**
 * Receives scores from `furrow live`, which passes face trackers on to pages.
 *
 * @module furrow/live
 */

export { connectLive, type LiveConnection, type LiveFrame, type LiveOptions } from './connect-live.ts'
