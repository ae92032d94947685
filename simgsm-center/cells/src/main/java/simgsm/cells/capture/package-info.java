/**
 * What a receiver at the aerial of a tower would see, as GSMTAP: blocks of the control channels, and bursts once they are ciphered.
 * Read {@link simgsm.cells.capture.AirCapture}.
 */
package simgsm.cells.capture;
