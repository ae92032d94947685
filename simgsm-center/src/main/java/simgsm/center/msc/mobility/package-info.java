/**
 * Mobility management on the network side. Read first: {@link simgsm.center.msc.mobility.MobilityProcedures}, then {@link
 * simgsm.center.msc.mobility.LocationUpdateTable}.
 */
package simgsm.center.msc.mobility;
