/**
 * The link between a terminal and the centre: IPA frames, CCM, RSL (TS 48.058) and RTP. Read {@link simgsm.abis.IpaFramer}.
 */
package simgsm.abis;
