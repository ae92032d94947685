/**
 * The phone's stored data: messages in folders, the log of calls, and the names of the SIM's phone book. Owned by the
 * station's thread; returned lists never change.
 *
 * <p>Read first: {@link simgsm.phone.store.Mailbox}, then {@link simgsm.phone.store.CallLog} and {@link
 * simgsm.phone.store.Contacts}.
 */
package simgsm.phone.store;
