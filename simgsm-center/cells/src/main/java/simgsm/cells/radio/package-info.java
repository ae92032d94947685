/** What a mobile receives where. Read {@link simgsm.cells.radio.Radio}. */
package simgsm.cells.radio;
