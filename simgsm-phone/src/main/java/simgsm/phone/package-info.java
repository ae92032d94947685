/** M1: the phone. */
package simgsm.phone;
