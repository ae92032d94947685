/** Short messages on an AT line: as PDU, and as text with header fields (TS 27.005, 3 and 4). */
package simgsm.modem.at.sms;
