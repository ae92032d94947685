/**
 * One mobile station: a core ({@link simgsm.station.MobileStation}), and the thread that gives it time and a socket
 * ({@link simgsm.station.StationThread}).
 *
 * <p>Read first: {@link simgsm.station.MobileStation}, then {@link simgsm.station.StationCommands} and {@link
 * simgsm.station.context.StationEvent}.
 * <pre>
 *   station --> call, sms, ss --> mobility --> context
 * </pre>
 */
package simgsm.station;
