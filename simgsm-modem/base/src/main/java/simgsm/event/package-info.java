/** Events as records: {@link simgsm.event.EventLine} declares the printed line, {@link simgsm.event.EventForm} reads the fields. */
package simgsm.event;
