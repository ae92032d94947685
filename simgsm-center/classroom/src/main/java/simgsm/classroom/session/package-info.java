/**
 * A centre and programs that are started beside it by name: their consoles, waiting for events, their end. Read {@link
 * simgsm.classroom.session.Consoles} first.
 */
package simgsm.classroom.session;
