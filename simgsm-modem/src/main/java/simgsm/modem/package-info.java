/** M2: the GSM modem on top of a mobile station. */
package simgsm.modem;
