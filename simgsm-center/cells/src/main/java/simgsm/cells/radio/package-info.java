/** What a mobile receives where. Read {@link simgsm.cells.radio.RadioField}. */
package simgsm.cells.radio;
