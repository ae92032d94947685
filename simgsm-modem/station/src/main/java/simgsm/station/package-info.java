/**
 * The mobile station: registration, one call at a time, short messages. A pure core ({@link simgsm.station.MobileStation})
 * and the one thread that gives it time and a socket ({@link simgsm.station.StationThread}).
 *
 * <p>Read first: {@link simgsm.station.MobileStation}, then {@link simgsm.station.StationListener}, then
 * {@link simgsm.station.CallState}.
 */
package simgsm.station;
