/** A mobile's reception at each place. Read {@link simgsm.cells.radio.RadioField} first. */
package simgsm.cells.radio;
