/**
 * The short message centre's store on disk: segments of records with checksums, and snapshots that replace all segments
 * before them.
 *
 * <p>Read first: {@link simgsm.center.journal.Journal}; then {@code Recovery}, {@code JournalState}, {@code Compaction}, and
 * {@link simgsm.center.journal.JournalThread}, which drives it.
 */
package simgsm.center.journal;
