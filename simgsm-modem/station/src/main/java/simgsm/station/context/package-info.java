/** What all machines of one station share: identity, log, timers, radio connection, and the events that they report. Read first: {@link simgsm.station.context.StationContext}. */
package simgsm.station.context;
