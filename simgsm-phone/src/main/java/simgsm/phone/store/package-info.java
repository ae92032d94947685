/**
 * What the phone keeps: messages in folders, the log of calls, and the names of the SIM's phone book. It belongs to the
 * station's owner thread; lists that it hands out never change.
 *
 * <p>Read first: {@link simgsm.phone.store.Mailbox}, then {@link simgsm.phone.store.CallLog} and
 * {@link simgsm.phone.store.Contacts}.
 */
package simgsm.phone.store;
