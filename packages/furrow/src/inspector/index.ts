/**
 * A panel to inspect wrinkles on any three.js page, with either renderer.
 *
 * @module furrow/inspector
 */

export { WrinkleInspector } from './WrinkleInspector.ts'
