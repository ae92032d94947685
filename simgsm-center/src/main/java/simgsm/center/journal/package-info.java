/**
 * The short message centre's store on disk. Segments of checksummed records, appended to in groups; snapshots that stand
 * for all segments before them; recovery that saves what can be saved and says what cannot. Above smsc, whose
 * {@link simgsm.center.smsc.MessageStore} it is.
 *
 * <p>Read first: {@link simgsm.center.journal.Journal}; then {@code Recovery}, {@code Ledger} and {@code Compaction}, and
 * {@link simgsm.center.journal.JournalThread} for who drives it.
 */
package simgsm.center.journal;
