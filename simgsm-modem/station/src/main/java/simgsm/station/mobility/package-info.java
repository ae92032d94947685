/** Mobility management of the mobile (TS 24.008, 4): registration, the SIM's answers, and connections for calls and messages. Read first: {@link simgsm.station.mobility.MobileRegistration}. */
package simgsm.station.mobility;
