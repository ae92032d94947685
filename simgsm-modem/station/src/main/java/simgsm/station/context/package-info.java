/**
 * Objects shared by all machines of one station: identity, log, timers, radio connection, and their events. Read
 * first: {@link simgsm.station.context.StationContext}.
 */
package simgsm.station.context;
