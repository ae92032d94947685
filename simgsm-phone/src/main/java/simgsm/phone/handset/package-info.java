/**
 * The phone without a window: the number being typed, the call and its keys, received tones, messages, screens. A
 * core on the station's owner thread; time is passed in nanoseconds, views take immutable snapshots.
 * <pre>
 *   station's events --> Handset --> PhoneCall, HandsetStore, HandsetAudio, HandsetLog
 *   key pressed      --> HandsetKeys --> HomeKeys or ScreenNavigation --> KeyIntent --> Handset performs it:
 *   tone             --> HandsetAudio --> KeySender --> DtmfGenerator --> speech frames
 * </pre>
 *
 * <p>Read first: {@link simgsm.phone.handset.Handset}, then {@link simgsm.phone.handset.HandsetSnapshot} and {@link
 * simgsm.phone.handset.HandsetKeys}.
 */
package simgsm.phone.handset;
