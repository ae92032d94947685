/**
 * What the phone is, without a window: the number being typed, the call and its keys, the tones heard by ear, messages,
 * screens. A pure core on the station's owner thread; time comes in as nanoseconds, views take immutable snapshots.
 *
 * <pre>
 *   StationEars --> Handset --> Screens --> TextEntry
 *                   |     \        |
 *                 Sounds  HomeKeys Mailbox
 *                 |    \
 *          KeySender  Earpiece
 *             |
 *          InBandKeys, or SignalledKeys towards the station
 * </pre>
 *
 * <p>Read first: {@link simgsm.phone.handset.Handset}, then {@link simgsm.phone.handset.HandsetSnapshot} and
 * {@link simgsm.phone.handset.Screen}.
 */
package simgsm.phone.handset;
