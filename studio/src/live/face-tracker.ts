/** Separate module, so that the bundler puts the tracker into a chunk that only live sources download. */
export { FaceTracker } from 'furrow/three'
