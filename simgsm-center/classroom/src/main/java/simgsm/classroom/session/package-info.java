/**
 * A centre and programs started by name: their consoles, waiting for events, their end. Read {@link
 * simgsm.classroom.session.Consoles} first.
 */
package simgsm.classroom.session;
