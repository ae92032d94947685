/**
 * The link between a terminal and the centre: IPA frames, CCM, RSL (TS 48.058) and RTP. Read {@link
 * simgsm.abis.IpaFramer} first; {@link simgsm.abis.IpaConnection} is their socket.
 */
package simgsm.abis;
